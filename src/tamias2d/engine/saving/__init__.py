"""An engine saved, checked as it is read, and copied in memory."""
