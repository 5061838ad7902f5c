"""Tests of bodies that are followed from impact to impact by compiled code."""
