"""Writes the example programs of host-sim/examples; run ../make_examples.py."""
