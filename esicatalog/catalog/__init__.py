"""The relational catalog. The modules mapping, digests and rows are pure: worker processes use them without SQLAlchemy."""
