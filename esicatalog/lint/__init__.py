"""The linter: rules L01 to L67 about ESI documents, one function each, with severity, line and reference."""
