"""The linter: rules about ESI documents, one function each, with severity, line and reference."""
