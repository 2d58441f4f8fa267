"""esicatalog: the catalog of EtherCAT devices, made from the vendors' ESI files."""

__version__ = "0.1.0"
