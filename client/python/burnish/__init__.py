"""Edits the fine detail of 3D scans, on a Burnish server or on this computer."""
