import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Examples",
    hint: "They open as copies: run them, then take them apart and change them.",
  },
  search: "Search the help",
  nothing: "Nothing with these words. Try others.",
  tryIt: "Try it",
  tryItHelp: "Puts the block into the program",
  openExample: "Open a copy",
  moreInLevel: "There are more blocks for this in another level.",
  tabs: {
    tasks: "What can I do?",
    blocks: "Blocks",
    keys: "Keys",
  },
  tasks: {
    drive: "Drive and turn",
    draw: "Draw on the floor",
    sense: "Sense what is around",
    decide: "Decide",
    repeat: "Repeat",
  },
  keys: {
    blocks: "Blocks",
    palette: "Go to the categories of blocks",
    program: "Go to the program",
    arrows: "Walk among the blocks",
    enter: "Put the block; change a number",
    move: "Move the block with the arrows",
    remove: "Delete the block",
    copy: "Copy and paste",
    escape: "Leave what is open",
    tab: "Go to the next part of the screen",
  },
};
