"""Exchange between stores: bundles, merging, deletion for good, anonymous export, Parquet."""
