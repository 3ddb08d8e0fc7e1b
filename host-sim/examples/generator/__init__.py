"""Package that writes the example programs of host-sim/examples. Run ../make_examples.py."""
