"""Window and single instance: the only import of pywebview."""
