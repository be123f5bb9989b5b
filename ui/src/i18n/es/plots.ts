import type { plots as first } from "../pt-BR/plots";

export const plots: typeof first = {
  label: "Gráficos del recorrido",
  open: "Gráficos",
  empty: "Presionen Ejecutar y los gráficos aparecen aquí.",
  larger: "Agrandar el gráfico",
  smaller: "Achicar el gráfico",
  save: "Guardar gráfico o tabla",
  picture: "Imagen del gráfico (PNG)",
  table: "Tabla de las mediciones (CSV)",
  keys: "Las flechas eligen el momento.",
  time: "tiempo",
  figures: {
    path: "Camino",
    position: "Posición",
    heading: "Dirección",
    speed: "Velocidad",
    turning: "Giro",
  },
  titles: {
    path: "Camino del robot en el piso",
    position: "Dónde está el robot: x e y en el tiempo",
    heading: "Hacia dónde mira el robot en el tiempo",
    speed: "Velocidad hacia adelante: pedida y medida",
    turning: "Velocidad de giro: pedida y medida",
  },
  quantities: { position: "x e y", heading: "dirección", speed: "velocidad", turning: "giro" },
  roles: {
    obtained: "obtenido",
    desired: "deseado",
    true: "verdadero",
    commanded: "pedido",
    measured: "medido",
  },
};
