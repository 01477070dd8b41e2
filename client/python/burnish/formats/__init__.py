"""Decodes pages and frames by docs/protocol.md alone."""
