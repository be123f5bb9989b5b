import type { PageTexts } from "./catalogue_types";
import type { BlocklyMessages, Catalogue } from "./message";

/** The texts of the page in one language. Those of the lazy parts are missing before one of them is shown. */
export interface Texts extends PageTexts {
  /** Blockly's own messages, in our words where we have some. */
  readonly blockly: BlocklyMessages;
  /** Why a run ended. */
  readonly reasons: Catalogue;
  /** What is wrong with the camera, and with the recording of a sign. */
  readonly cameraProblems: Catalogue;
  /** What each number of the review counts. */
  readonly figures: Catalogue;
}
