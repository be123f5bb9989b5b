import type * as Blockly from "blockly/core";
import { knownPlaces } from "../../blocks/known_places";
import { COLOURS } from "../../blocks/table/arguments";
import { type TextKey, word } from "../../blocks/words";
import { commandOf, comparedWith } from "./compared";

/** Texts on blocks of values; a letter is one, too. */
const TEXTS = ["text", "text_letter"];

/**
 * What each command is told of a text that is never equal to what it is compared with: a colour that the floor never
 * has, a place that the world does not have; and of a place to drive to that it does not have. No fault: such a program runs.
 */
export function impossibleIn(workspace: Blockly.Workspace): Map<string, Set<string>> {
  const found = new Map<string, Set<string>>();
  for (const block of workspace.getAllBlocks(false)) {
    const words = TEXTS.includes(block.type) ? wordsOf(block) : [];
    const command = words.length > 0 ? commandOf(block) : null;
    if (!command) continue;
    const told = found.get(command.id) ?? new Set();
    found.set(command.id, new Set([...told, ...words]));
  }
  return found;
}

function wordsOf(block: Blockly.Block): string[] {
  const text = String(block.getFieldValue("TEXT"));
  switch (comparedWith(block)?.type) {
    case "floor":
      return wordsOfColour(text);
    case "cell":
      return wordsOfPlace(text);
    default:
      return block.getParent()?.type === "go_to_place" ? wordsOfGoal(text) : [];
  }
}

function wordsOfColour(text: string): string[] {
  if (COLOURS.some((colour) => colour === text)) return [];
  const shown = COLOURS.map((colour) => word(`COLOUR_${colour.toUpperCase()}` as TextKey));
  const meant = shown.find((name) => name.toLowerCase() === text.trim().toLowerCase());
  return [
    word("COLOUR_NEVER", text),
    meant ? word("COLOUR_BLOCK", meant) : word("COLOUR_BLOCKS", shown.join(", ")),
  ];
}

/** Outside of all places the name is "". */
function wordsOfPlace(text: string): string[] {
  const places = knownPlaces();
  if (places === null || text === "" || places.includes(text)) return [];
  return [
    word("PLACE_NEVER", text),
    places.length > 0 ? word("PLACE_NAMES", places.join(", ")) : word("PLACE_NONE"),
  ];
}

/** A place to drive to is found in any case. */
function wordsOfGoal(text: string): string[] {
  const places = knownPlaces();
  const wanted = text.trim().toLowerCase();
  if (places === null || wanted === "") return [];
  if (places.some((place) => place.toLowerCase() === wanted)) return [];
  return [
    word("PLACE_NEVER", text),
    places.length > 0 ? word("PLACES_ARE", places.join(", ")) : word("PLACE_NONE"),
  ];
}
