"""ESI documents (ETG.2000): opening, reading into records, references."""
