"""Tests of discs that are followed from impact to impact by compiled code."""
