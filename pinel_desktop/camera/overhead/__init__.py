"""Where a robot truly is, seen by a camera above the floor. Pure, on OpenCV: no camera, clock or thread."""
