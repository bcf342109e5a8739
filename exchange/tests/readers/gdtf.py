"""Prints the beams of GDTF files as pygdtf reads them: name, beam angle, field angle, lumens, by tabs."""

import sys

import pygdtf

for path in sys.argv[1:]:
    fixture = pygdtf.FixtureType(path)
    waiting = list(fixture.geometries)
    while waiting:
        node = waiting.pop(0)
        if isinstance(node, pygdtf.GeometryBeam):
            print(node.name, node.beam_angle, node.field_angle, node.luminous_flux, sep="\t")
        waiting[:0] = getattr(node, "geometries", [])
