import cameraMessages from "../../../../pinel_desktop/messages/catalogue/pt-BR/camera.json";
import gestureMessages from "../../../../pinel_desktop/messages/catalogue/pt-BR/gestures.json";
import figures from "../../../../pinel_desktop/messages/catalogue/pt-BR/review.json";
import type { Catalogue } from "../message";
import { camera, practice, teaching } from "./camera";
import { exchange } from "./exchange";
import { help } from "./help";
import { plan } from "./plan";
import { review } from "./review";
import { making, robotSetup, teacher } from "./teacher";

export const lazy = {
  camera,
  /** What is wrong with the camera, and with the recording of a sign. */
  cameraProblems: { ...cameraMessages, ...gestureMessages } as Catalogue,
  exchange,
  /** What each number of the review counts. */
  figures: figures as Catalogue,
  help,
  plan,
  making,
  practice,
  review,
  robotSetup,
  teacher,
  teaching,
};
