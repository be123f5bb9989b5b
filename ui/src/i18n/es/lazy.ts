import cameraMessages from "../../../../pinel_desktop/messages/catalogue/es/camera.json";
import gestureMessages from "../../../../pinel_desktop/messages/catalogue/es/gestures.json";
import figures from "../../../../pinel_desktop/messages/catalogue/es/review.json";
import type { LazyTexts } from "../texts";
import { camera, practice, teaching } from "./camera";
import { exchange } from "./exchange";
import { help } from "./help";
import { plan } from "./plan";
import { review } from "./review";
import { making, robotSetup, teacher } from "./teacher";

export const lazy: LazyTexts = {
  camera,
  cameraProblems: { ...cameraMessages, ...gestureMessages },
  exchange,
  figures,
  help,
  plan,
  making,
  practice,
  review,
  robotSetup,
  teacher,
  teaching,
};
