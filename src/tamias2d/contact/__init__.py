class Refusal(Exception): pass
class Located:
    can_meet = False
    def __init__(self, scene, motion): pass
