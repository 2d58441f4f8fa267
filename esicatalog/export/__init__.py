"""Generators: from records and a chosen configuration to text or bytes, one module a target."""
