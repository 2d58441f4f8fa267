"""The catalog in a browser: the Datasette plugin and the application that ``esicatalog serve`` runs."""
