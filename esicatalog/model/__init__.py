"""What ESI implies and does not say: pure functions over records."""
