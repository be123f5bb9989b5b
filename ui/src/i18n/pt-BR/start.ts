import * as blockly from "blockly/msg/pt-br";
import program from "../../../../pinel_desktop/messages/catalogue/pt-BR/program.json";
import robots from "../../../../pinel_desktop/messages/catalogue/pt-BR/robots.json";
import run from "../../../../pinel_desktop/messages/catalogue/pt-BR/run.json";
import type { BlocklyMessages, Catalogue } from "../message";
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

export const start = {
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
  blockly: { ...(blockly as object), ...editor } as BlocklyMessages,
  /** Why a run ended. */
  reasons: { ...program, ...robots, ...run } as Catalogue,
};
