"""The linter: rules L01 to L68 about ESI documents, one function each, with severity, line and reference."""
