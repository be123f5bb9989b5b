"""One file per block category: what each command does."""
