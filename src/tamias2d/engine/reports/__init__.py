"""What steps tell: contacts, their beginning and end, and walls that leave a gap."""
