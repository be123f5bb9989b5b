import type * as Blockly from "blockly/core";
import { knownPlaces } from "../../blocks/known_places";
import { COLOURS } from "../../blocks/table/arguments";
import { blockText, type TextKey } from "../../blocks/texts";
import { commandOf, comparedWith } from "./compared";

/** Types of blocks that hold a text. */
const TEXTS = ["text", "text_letter"];

/**
 * Warnings by command about texts that never match: a colour that the floor sensor never gives, or
 * a place that the world does not have. They are no faults: the program runs.
 */
export function impossibleIn(workspace: Blockly.Workspace): Map<string, Set<string>> {
  const found = new Map<string, Set<string>>();
  for (const block of workspace.getAllBlocks(false)) {
    const texts = TEXTS.includes(block.type) ? textsOf(block) : [];
    const command = texts.length > 0 ? commandOf(block) : null;
    if (!command) continue;
    const previous = found.get(command.id) ?? new Set();
    found.set(command.id, new Set([...previous, ...texts]));
  }
  return found;
}

function textsOf(block: Blockly.Block): string[] {
  const text = String(block.getFieldValue("TEXT"));
  switch (comparedWith(block)?.type) {
    case "floor":
      return colourTexts(text);
    case "cell":
      return placeTexts(text);
    default:
      return block.getParent()?.type === "go_to_place" ? goalTexts(text) : [];
  }
}

function colourTexts(text: string): string[] {
  if (COLOURS.some((colour) => colour === text)) return [];
  const shown = COLOURS.map((colour) => blockText(`COLOUR_${colour.toUpperCase()}` as TextKey));
  const meant = shown.find((name) => name.toLowerCase() === text.trim().toLowerCase());
  return [
    blockText("COLOUR_NEVER", text),
    meant ? blockText("COLOUR_BLOCK", meant) : blockText("COLOUR_BLOCKS", shown.join(", ")),
  ];
}

/** The sensor gives "" outside of all places, so "" is valid. */
function placeTexts(text: string): string[] {
  const places = knownPlaces();
  if (places === null || text === "" || places.includes(text)) return [];
  return [
    blockText("PLACE_NEVER", text),
    places.length > 0 ? blockText("PLACE_NAMES", places.join(", ")) : blockText("PLACE_NONE"),
  ];
}

/** Unlike a comparison, driving to a place ignores case. */
function goalTexts(text: string): string[] {
  const places = knownPlaces();
  const goal = text.trim().toLowerCase();
  if (places === null || goal === "") return [];
  if (places.some((place) => place.toLowerCase() === goal)) return [];
  return [
    blockText("PLACE_NEVER", text),
    places.length > 0 ? blockText("PLACES_ARE", places.join(", ")) : blockText("PLACE_NONE"),
  ];
}
