import {
  Anchor,
  Apple,
  Bike,
  Bird,
  Cat,
  Cherry,
  Crown,
  Dog,
  Fish,
  Flower,
  Guitar,
  Moon,
  Mountain,
  Plane,
  Rabbit,
  Rocket,
  Ship,
  Snail,
  Squirrel,
  Star,
  Sun,
  TreeDeciduous,
  Turtle,
  Umbrella,
} from "lucide-preact";

/** Pictures for groups, in the order of the choice. The server declares the same names. */
export const PICTURES = {
  rocket: Rocket,
  cat: Cat,
  tree: TreeDeciduous,
  fish: Fish,
  star: Star,
  bird: Bird,
  bike: Bike,
  sun: Sun,
  turtle: Turtle,
  guitar: Guitar,
  flower: Flower,
  snail: Snail,
  ship: Ship,
  rabbit: Rabbit,
  mountain: Mountain,
  dog: Dog,
  umbrella: Umbrella,
  cherry: Cherry,
  plane: Plane,
  crown: Crown,
  squirrel: Squirrel,
  anchor: Anchor,
  apple: Apple,
  moon: Moon,
} as const;

export type PictureName = keyof typeof PICTURES;

export const PICTURE_NAMES = Object.keys(PICTURES) as PictureName[];

export function isPicture(name: string): name is PictureName {
  return Object.hasOwn(PICTURES, name);
}
