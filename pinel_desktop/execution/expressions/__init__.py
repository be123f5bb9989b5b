"""Values, operators, variables, and the evaluation of expressions."""
