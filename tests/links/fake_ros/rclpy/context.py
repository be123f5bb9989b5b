class Context:
    n_nodes = 0
