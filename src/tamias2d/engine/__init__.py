"""The contact engine: steps of many bodies that touch, fast and always to an end (IM9 to IM12).

Serves: the simulator. Hides: all arrays and their compiled code. `tables` declares the arrays,
`step` is the list of stages, and each folder is one of them.
"""
