"""The relational catalog. Mapping, digests and rows are pure: worker processes use them without SQLAlchemy."""
