import { Download, Upload } from "lucide-preact";
import { NO_CLASS } from "../api/classes";
import { exchange } from "../api/exchange";
import type { Group, Program } from "../api/model";
import { texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import { Button } from "../kit/Button";
import { setClassroom } from "../shell/classroom";
import { FileButton } from "../shell/files/FileButton";
import { fileName, saveFile } from "../shell/files/save_file";
import { go } from "../shell/route";
import { problem } from "../shell/session";

const SUFFIX = ".pinel";

/** Exports a program as a file, for another PC. */
export function ExportProgram({ program }: { program: Program }) {
  const { programFile } = texts.value;
  const exportFile = async () => {
    const { octets, leftOut } = await exchange.programFile(program.id);
    saveFile(`${fileName(program.name, "programa")}${SUFFIX}`, octets);
    problem.value = leftOut;
  };
  return (
    <Button
      kind="plain"
      icon={Download}
      label={labelled(programFile.takeAlong, program.name)}
      tip={programFile.takeAlongHint}
      testId="program-file"
      onPress={exportFile}
    >
      {programFile.take}
    </Button>
  );
}

/** Exports all work of a group as a file, for a PC that does not keep it. */
export function ExportGroup({ group }: { group: Group }) {
  const exportFile = async () => {
    const { octets, leftOut } = await exchange.groupFile(group.id);
    saveFile(`${fileName(group.name, "grupo")}${SUFFIX}`, octets);
    problem.value = leftOut;
  };
  return (
    <Button icon={Download} testId="group-file" onPress={exportFile}>
      {texts.value.programFile.takeGroup}
    </Button>
  );
}

/** Imports programs with their group from a file, and opens the newest. */
export function ImportProgram() {
  const { programFile } = texts.value;
  const importFile = async (file: File) => {
    const brought = await exchange.bringProgram(file);
    setClassroom(brought.classroom_id ?? NO_CLASS);
    go({ screen: "studio", program: brought.program_id });
  };
  return (
    <FileButton
      kind="plain"
      icon={Upload}
      accept={SUFFIX}
      testId="bring-program"
      onFile={importFile}
    >
      {programFile.bringIn}
    </FileButton>
  );
}
