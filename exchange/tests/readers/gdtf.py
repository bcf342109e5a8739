"""Prints name, beam angle, field angle and lumens of the beams of GDTF files as pygdtf reads them."""

import sys

import pygdtf

for path in sys.argv[1:]:
    waiting = list(pygdtf.FixtureType(path).geometries)
    while waiting:
        node = waiting.pop(0)
        waiting[:0] = getattr(node, "geometries", [])
        if isinstance(node, pygdtf.GeometryBeam):
            print(node.name, node.beam_angle, node.field_angle, node.luminous_flux, sep="\t")
