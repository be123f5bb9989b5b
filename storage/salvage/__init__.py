"""Reading what is still readable of a damaged file, and bringing it into a sound one."""
