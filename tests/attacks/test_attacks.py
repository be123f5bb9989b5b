"""The table of attacks: what a file, a sender or a process may try, and what PINEL does about it.

Each test is one attack, in a few lines that read as a sentence; how it is done lies in the modules beside this file.
docs/trust.md tells a school the same in plain words.
"""

# ---- a file that somebody made up ----

# ---- a file that somebody signed ----

# ---- a person at the page ----

# ---- a deletion that arrives with a file ----

# ---- a file that was damaged ----

# ---- a value that was damaged ----

# ---- a process that hangs or grows ----
