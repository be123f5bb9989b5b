"""Every message a person can meet, by code, in Portuguese, English and Spanish."""
