"""What travels between stores: bundles, merging, deletion, anonymous export, Parquet."""
