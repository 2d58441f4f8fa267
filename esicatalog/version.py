"""Version of the package; documents are read anew when it changes."""

__version__ = "0.4.11"
