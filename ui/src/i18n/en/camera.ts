import { namedSign } from "./named_sign";

/** The camera that sees signs, and practising them. */
export const camera = {
  picture: "Picture of the camera, as in a mirror",
  opening: "Opening the camera…",
  choose: "Which camera to use",
  number: (n: number) => `Camera ${n}`,
  other: "Another source",
  showHand: "Show your hand",
  noLetter: "No letter recognised yet",
  twoSigns: "There are two hands: show one only",
  unsure: "Not certain yet:",
  either: (one: string, other: string) => `${one} or ${other}?`,
  orElse: (letter: string) => `or ${letter}`,
  hold: "Keep your hand still",
  sure: (sign: string, share: string) => `${namedSign(sign)}, with ${share} certainty`,
  steady: "How long until the sign counts",
  expected: "The program expects:",
  sign: (sign: string) => `Drawing: ${namedSign(sign)}`,
  noDrawing: (sign: string) => `${namedSign(sign)}, without a drawing yet`,
  hands: {
    left: "Drawings of the left hand: change",
    right: "Drawings of the right hand: change",
  },
};

export const practice = {
  hint: "Make a letter of the Libras manual alphabet and keep your hand still.",
  seen: "What the camera sees",
  spelled: "Done! Make the next letter.",
  imitate: "Make this letter",
  choose: "Letter to make",
  hand: "Hand",
  right: "Right",
  left: "Left",
  matched: (sign: string) => `That is it! ${namedSign(sign)}.`,
  text: "What you have spelled",
  placeholder: "The letters appear here",
  space: "Space",
  back: "Delete letter",
  clear: "Clear",
  bringBack: "Bring it back",
  moving:
    "The camera does not know H, J, X, Z and Ç yet, which move, nor Y: use the keyboard, or teach these letters (experimental). Of K it reads only the still hand, without the movement.",
  credits:
    "Letters learnt from “Alfabeto em libras” (elainesilva, CC BY 4.0); hands: MediaPipe (Apache 2.0).",
};

/** Signs that a class teaches the camera. */
export const teaching = {
  title: "Teach a letter or a sign",
  name: "Letter, or name of the sign",
  record: "Record",
  samples: (n: number) => `${n} pictures`,
  forget: (sign: string) => `Delete what was recorded of ${sign}`,
  counted: (sign: string, n: number, of: number) => `${sign}: ${n} of ${of}. Keep your hand still.`,
  kind: "How the sign is made",
  still: "It keeps still",
  moves: "It moves",
  experimental: "experimental",
  suggested: "Letters still missing",
  howStill: "Keep your hand still until ten pictures are recorded.",
  howMoving:
    "Do this five times: keep your hand still, make the movement, and keep it still again.",
  movements: (n: number) => (n === 1 ? "1 movement" : `${n} movements`),
  countedMoving: (sign: string, n: number, of: number) =>
    `${sign}: ${n} of ${of}. Keep your hand still, make the movement, and keep it still again.`,
  learnt: (sign: string) => `Done: the camera knows the sign ${sign}.`,
};
