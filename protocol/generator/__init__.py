"""Generator of the wire protocol: protocol.yml to C++, Python, documentation and golden vectors.

Run ``python -m protocol.generator`` from the repository's root; ``--check`` compares instead of writing.
"""
