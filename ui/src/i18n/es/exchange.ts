import type { exchange as first } from "../pt-BR/exchange";

export const exchange: typeof first = {
  title: "Memoria USB y carpeta de la escuela",
  intro:
    "Aquí los trabajos de muchas computadoras se vuelven un solo conjunto. Unir dos veces el mismo archivo no cambia nada, y el orden no importa.",
  places: "Dónde están los archivos",
  lookAgain: "Buscar otra vez",
  nowhere: "No se encontró ninguna memoria USB.",
  nowhereHint: "Conecte una y espere un momento, o elija la carpeta de la escuela aquí abajo.",
  stick: (name: string) => `Memoria USB ${name}`,
  folder: (name: string) => `Carpeta ${name}`,
  free: (size: string) => `${size} libres`,
  readOnly: "solo se puede leer",
  unreachable: "no responde ahora",
  noFiles: "Todavía sin archivos de PINEL.",
  file: (size: string, when: string) => `${size} · ${when}`,
  nameless: "Sin nombres",
  doubles:
    "Este archivo trae grupos llamados “Grupo 1”, “Grupo 2”… Si ya están aquí, aparecen dos veces, y solo se deshace borrándolos para siempre.",
  cameNameless: "Llegaron sin nombres: los grupos se llaman “Grupo 1”, “Grupo 2”…",
  choose: (name: string) => `Unir ${name}`,
  merge: (n: number) => (n === 1 ? "Unir 1 archivo" : `Unir ${n} archivos`),
  merging: (n: number, of: number) => `Uniendo ${n} de ${of}…`,
  saveHere: "Guardar los trabajos",
  anonymous: "Sin nombres ni textos",
  anonymousHint: "Para mostrar a otros: no dice de quién es el trabajo.",
  saving: "Guardando…",
  what: "Qué guardar",
  everything: "Todo lo de esta computadora",
  onlyClass: (name: string) => `Solo el curso ${name}`,
  saved: (name: string, groups: string, runs: string) =>
    `Guardado en ${name}: ${groups} y ${runs}.`,
  takeOut: "Ya puede quitar la memoria USB.",
  saveIn: (folder: string) => `Guardar en “${folder}”`,
  results: "Qué llegó",
  brought: (computer: string, parts: string) => `${computer}: ${parts}.`,
  lessonCame: "Este es un archivo de clase. Para abrir la clase aquí, vaya a “Clases”.",
  nothingNew: (computer: string) => `${computer}: nada nuevo, ya estaba todo aquí.`,
  nothingComes: (computer: string) => `${computer}: nada nuevo.`,
  heldBack: (parts: string) => `No vuelve, porque se borró para siempre: ${parts}.`,
  heldBackRest: "Una parte de este archivo no vuelve, porque se borró para siempre.",
  deleted: (parts: string) => `Borrado: ${parts}.`,
  deletedRest: "Borrado aquí también.",
  only: (computer: string) => `${computer}: nombres y ajustes actualizados.`,
  groups: (n: number) => (n === 1 ? "1 grupo" : `${n} grupos`),
  programs: (n: number) => (n === 1 ? "1 programa" : `${n} programas`),
  versions: (n: number) => (n === 1 ? "1 versión" : `${n} versiones`),
  runs: (n: number) => (n === 1 ? "1 recorrido" : `${n} recorridos`),
  heard: "Computadoras con trabajos ya reunidos aquí",
  heardNobody: "Todavía no hay trabajos de otra computadora.",
  computer: "Computadora",
  exported: "Archivo hecho el",
  merged: "Unido el",
  heardRuns: "Recorridos",
  clock: "Las horas son las del reloj de cada computadora, que puede estar mal.",
  shared: "Carpeta de la escuela",
  sharedHint:
    "Una carpeta de la red o de esta computadora que aparece aquí como una memoria USB. Déjela vacía para no usar ninguna.",
  sharedExample: "Por ejemplo: \\\\servidor\\robotica o /red/robotica",
  sharedSilent: {
    message: "La carpeta de la escuela no responde ahora.",
    remedy:
      "Sigue elegida. Revise si la red está conectada o si la carpeta se abre en esta computadora.",
  },
  sharedBackups: "Guardar allí también las copias de seguridad de esta computadora",
  sharedBackupsHint: "Quien puede leer esa carpeta puede leer los trabajos de los grupos.",
  keepShared: "Usar esta carpeta",
  doomed: (computer: string, names: string, work: string) =>
    `En ${computer} se borró para siempre: ${names} (aquí todavía hay ${work}). ¿Borrarlo aquí también? No se puede deshacer.`,
  deleteToo: "Borrarlo aquí también",
  deleteRest: "Borrar el resto aquí también",
  undecided: {
    title: "Esperan su decisión",
    line: (computer: string, work: string) =>
      `En ${computer} se borró para siempre lo que aquí todavía hay: ${work}.`,
    file: (name: string, when: string) => `Archivo ${name}, ${when}`,
    ask: "Decidir ahora",
  },
  whatToKeep:
    "Marque lo que debe quedar, aquí y en todas las computadoras. Lo que no está marcado se borra:",
  programOf: (name: string, group: string) => `${name} (${group})`,
  isNow: (classroom: string) => `Está ahora en el curso ${classroom}.`,
  isNowWithout: "Está ahora sin curso.",
  isNew: (parts: string) => `Más nuevo aquí: ${parts}.`,
  edits: (n: number) => (n === 1 ? "1 cambio" : `${n} cambios`),
  kept: (names: string) => `Se mantiene en todas las computadoras: ${names}.`,
  keepHere: "No borrar nada",
  unconfirmed: {
    came: "El trabajo está aquí; las actividades cuentan cuando PINEL las haya comprobado, lo que hace solo.",
    waiting: (n: number) =>
      n === 1
        ? "1 recorrido espera la comprobación. PINEL comprueba solo mientras nadie ejecuta programas aquí."
        : `${n} recorridos esperan la comprobación. PINEL comprueba solo mientras nadie ejecuta programas aquí.`,
    wrong: (n: number) =>
      n === 1
        ? "1 recorrido no coincide: repetido aquí, el resultado fue otro. Su actividad no cuenta."
        : `${n} recorridos no coinciden: repetidos aquí, el resultado fue otro. Sus actividades no cuentan.`,
    wrongWhere: "La página de la clase muestra de qué grupo.",
    notRepeatable: (n: number) =>
      n === 1
        ? "1 recorrido no se puede repetir aquí, por ejemplo porque es de un robot de verdad. Cuenta si usted lo acepta en la página de la clase."
        : `${n} recorridos no se pueden repetir aquí, por ejemplo porque son de un robot de verdad. Cuentan si usted los acepta en la página de la clase.`,
  },
  deletion: {
    title: "Borrar para siempre",
    hint: "Para cuando un curso se despide o alguien pide que se borren sus datos. Todo desaparece de esta computadora y de las copias de seguridad, y ninguna memoria USB lo trae de vuelta.",
    what: "Qué borrar",
    nothing: "Elija un grupo o el curso…",
    group: (name: string) => `El grupo ${name}`,
    classroom: (name: string) => `Todo el curso ${name}, con sus grupos`,
    goes: (name: string, programs: string, runs: string) =>
      `${name}: se borrarán ${programs} y ${runs}. No se puede deshacer.`,
    go: "Borrar para siempre",
    cancel: "Dejarlo como está",
    done: (groups: string, programs: string, runs: string) =>
      `Borrado: ${groups}, ${programs}, ${runs}.`,
    left: "Borre también estos archivos, que todavía pueden contener esos trabajos:",
  },
};
