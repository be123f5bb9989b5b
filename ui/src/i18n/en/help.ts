import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Examples",
    hint: "They open as copies: run them, then take them apart and change them.",
  },
  search: "Search the help",
  nothing: "No results. Try other words.",
  tryIt: "Try it",
  tryItHelp: "Puts the block into the program",
  playFilm: "Watch again",
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
    arrows: "Move between blocks",
    enter: "Put the block; change a number",
    move: "Move the block with the arrows",
    remove: "Delete the block",
    copy: "Copy and paste",
    escape: "Leave what is open",
    tab: "Go to the next part of the screen",
  },
  tour: {
    title: "First drive",
    hello: "This is the robot. Shall we make it drive?",
    move: (block: string, start: string) => `Drag “${block}” to just below “${start}”.`,
    run: (run: string) => `Press ${run}.`,
    watch: "It drives 1 m; the lit block is what it is doing now.",
    watchOther: "The lit block is what it is doing now.",
    turn: (block: string) => `Now drag “${block}” to just below it. Which way will the robot go?`,
    again: "Run it and watch: the robot turns, but it does not drive.",
    end: (stop: string) =>
      `${stop} is always here. Everything is saved. Shall we go on to the first mission?`,
    other: "That works too. Run it and see.",
    go: "Let’s go",
    skip: "Skip",
    show: "Show me",
    mission: "Begin",
    free: "Explore freely",
    place: (n: number, all: number) => `Step ${n} of ${all}`,
  },
};
