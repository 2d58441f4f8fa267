"""Records of everything an ESI document says, in document order; see :mod:`esicatalog.esi.binding` for the notation.

The field documentation is also the documentation of the catalog's columns.
"""
