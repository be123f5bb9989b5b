import * as blockly from "blockly/msg/en";
import program from "../../../../pinel_desktop/messages/catalogue/en/program.json";
import robots from "../../../../pinel_desktop/messages/catalogue/en/robots.json";
import run from "../../../../pinel_desktop/messages/catalogue/en/run.json";
import type { StartTexts } from "../texts";
import { activity } from "./activity";
import { archive } from "./archive";
import { blocks } from "./blocks";
import { classes } from "./classes";
import { editor } from "./editor";
import { page } from "./page";
import { plots } from "./plots";
import { programFile } from "./program_file";
import { searchTerms } from "./search_terms";
import { robot, world } from "./world";

export const start: StartTexts = {
  ...page,
  activity,
  blocks,
  classes,
  archive,
  plots,
  programFile,
  robot,
  searchTerms,
  world,
  blockly: { ...(blockly as object), ...editor },
  reasons: { ...program, ...robots, ...run },
};
