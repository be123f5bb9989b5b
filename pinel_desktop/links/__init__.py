"""One file per backend that can drive a robot; open_link() opens one by name."""
