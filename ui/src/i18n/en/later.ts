import figures from "../../../../pinel_desktop/messages/catalogue/en/review.json";
import type { LaterTexts } from "../texts";
import { exchange } from "./exchange";
import { review } from "./review";
import { teacher } from "./teacher";

export const later: LaterTexts = { exchange, figures, review, teacher };
