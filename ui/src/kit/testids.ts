/** Test ids of the kit's own controls for the end-to-end tests. */
export const KIT_TEST = {
  notLoaded: "not-loaded", // where something could not be loaded
  tryAgain: "try-again",
  choosePicture: "choose-picture", // shows the drawings of a new group
  picture: "picture", // of each; data-name
} as const;
