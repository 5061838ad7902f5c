"""The names of the methods: on the command line, and as classes of `tamias2d.motion`.

The command line reads them without loading the classes, which would take longer than its answer.
"""

METHOD_NAMES = {
    "closed-form": "ClosedForm",
    "explicit-euler": "ExplicitEuler",
    "semi-implicit-euler": "SemiImplicitEuler",
    "velocity-verlet": "VelocityVerlet",
    "runge-kutta-4": "RungeKutta4",
    "yoshida-4": "Yoshida4",
    "exponential-drag": "ExponentialDrag",
    "dormand-prince-5": "DormandPrince5",
    "dop853": "Dop853",
    "legacy-2018": "Legacy2018",
    "reference": "Reference",
    "stepped": "Stepped",
}
