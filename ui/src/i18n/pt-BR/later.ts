import figures from "../../../../pinel_desktop/messages/catalogue/pt-BR/review.json";
import type { Catalogue } from "../message";
import { camera, practice, teaching } from "./camera";
import { exchange } from "./exchange";
import { review } from "./review";
import { teacher } from "./teacher";

export const later = {
  camera,
  exchange,
  /** What each number of the review counts. */
  figures: figures as Catalogue,
  practice,
  review,
  teacher,
  teaching,
};
