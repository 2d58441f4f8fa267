"""What the pages show: view models of plain values for the templates."""
